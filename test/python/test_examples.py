"""test_examples.py SOURCE_DIR: every Python example of docs/python.md runs, in the order of the page."""
import os
import re
import sys
import tempfile
import unittest

SOURCE = sys.argv.pop(1)


class Examples(unittest.TestCase):
    def test_python_page(self):
        with open(os.path.join(SOURCE, "docs", "python.md"), encoding="utf-8") as page:
            examples = re.findall(r"^```python\n(.*?)^```", page.read(), re.DOTALL | re.MULTILINE)
        self.assertGreaterEqual(len(examples), 4)
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            os.symlink(os.path.join(SOURCE, "benchmarks"), "benchmarks")
            for example in examples:
                # campaigns as short as a test may be
                example = example.replace('"benchmarks/configs/paper_scene.cfg", "out', '"short.cfg", "out')
                with open(os.path.join(SOURCE, "benchmarks", "configs", "paper_scene.cfg"), encoding="utf-8") as config:
                    short = re.sub(r"(?m)^time_limit *=.*", "time_limit = 0.2", config.read())
                short = re.sub(r"(?m)^run_count *=.*", "run_count = 2", short)
                short = re.sub(r"(?m)^world *= *", "world = benchmarks/configs/", short)
                with open("short.cfg", "w", encoding="utf-8") as out:
                    out.write(short)
                exec(compile(example, "example", "exec"), {})  # pylint: disable=exec-used
            os.chdir(SOURCE)


if __name__ == "__main__":
    unittest.main()
