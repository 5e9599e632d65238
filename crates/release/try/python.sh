#!/usr/bin/env bash
# Uses the packed Python package as a user would: python.sh [--sdist]
#
# A fresh virtual environment outside the repository gets the wheel of target/artefacts/python that fits this machine. It runs the
# programs of the package's description, and mypy checks a program of a user. `--sdist` also builds the source distribution, without
# the repository, in an environment of its own; that takes minutes. PYTHON names another interpreter than python3.
set -euo pipefail
cd "$(dirname "$0")/../../.."
. crates/release/try/lib.sh

artefacts=$PWD/target/artefacts/python
package=$(sed -n 's/^python = "\(.*\)"/\1/p' crates/release/release.toml)
user=$(mktemp -d)
trap 'rm -rf "$user"' EXIT
cp crates/release/try/typed.py "$user"
cd "$user"
python=${PYTHON:-python3}
export PIP_DISABLE_PIP_VERSION_CHECK=1

# The package comes from the folder, and its dependencies from the registry.
install_wheel() {
    "$python" -m venv wheel &&
        wheel/bin/pip install --quiet --no-deps --no-index --only-binary :all: --find-links "$artefacts" "$package" &&
        wheel/bin/pip install --quiet "$package"
}

install_sources() {
    "$python" -m venv sources &&
        sources/bin/pip install --quiet "$artefacts"/*.tar.gz
}

# programs ENVIRONMENT: runs the programs in the description of the installed package.
programs() {
    "$1/bin/python" - "$package" <<'TEXT'
import importlib.metadata
import re
import subprocess
import sys

description = importlib.metadata.metadata(sys.argv[1]).get_payload()
programs = re.findall(r"^```python\n(.*?)^```$", description, re.DOTALL | re.MULTILINE)
assert programs, "the description has no program"
assert f"pip install {sys.argv[1]}\n" in description, "the description does not name the package"
for program in programs:
    subprocess.run([sys.executable, "-c", program], check=True)
TEXT
}

# The strict check also reports marks of mistakes that it does not find.
types() {
    wheel/bin/pip install --quiet mypy &&
        wheel/bin/mypy --strict typed.py &&
        wheel/bin/python typed.py
}

heading
row "\`pip install\` of the wheel, $("$python" --version)" install_wheel
row 'programs of the description, with the wheel' programs wheel
row 'a typed program: `mypy --strict`, and its run' types
if [ "${1:-}" = --sdist ]; then
    row '`pip install` of the source distribution' install_sources
    row 'programs of the description, with the source distribution' programs sources
fi
exit "$failures"
