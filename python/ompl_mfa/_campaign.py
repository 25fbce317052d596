"""Runs one campaign: a process of its own, because a campaign starts its runs by fork() and that needs a process with
one thread. Started by ompl_mfa.benchmark() as a script, so that neither NumPy nor the package is imported."""
import json
import sys

import _core

if __name__ == "__main__":
    try:
        _core.run_campaign(**json.loads(sys.argv[1]))
    except _core.InputError as error:
        sys.exit(f"InputError: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
