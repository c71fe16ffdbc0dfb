"""Every JSON and YAML file parses, strictly. Run: python3 tools/check_repository.py [tree]"""
import json
import pathlib
import sys

import yaml

root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)


def refuse(word):
    raise ValueError(f"{word} is no JSON")


parsers = {
    ".json": lambda text: json.loads(text, parse_constant=refuse),
    ".jsonl": lambda text: [json.loads(line, parse_constant=refuse) for line in text.splitlines()],
    ".yml": yaml.safe_load,
    ".yaml": yaml.safe_load,
    ".cff": yaml.safe_load,
    ".clang-format": yaml.safe_load,
    ".clang-tidy": yaml.safe_load,
}
faults = count = 0
for top in sorted(root.iterdir()):
    if top.name in {".git", ".cache", "build", "out"}:
        continue
    for path in sorted(top.rglob("*")) if top.is_dir() else [top]:
        parse = parsers.get(path.suffix or path.name)
        if parse is None or not path.is_file():
            continue
        count += 1
        try:
            parse(path.read_text(encoding="utf-8"))
        except (ValueError, yaml.YAMLError) as error:
            print(f"{path.relative_to(root)}: {error}")
            faults += 1
print(f"data files: {count} parsed, {faults} faults")
sys.exit(1 if faults else 0)
