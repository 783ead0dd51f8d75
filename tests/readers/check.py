#!/usr/bin/env python3
"""Tables of a sweep, CSV and Parquet, read by DuckDB, Polars and pandas, and compared with each other and with a run.

    check.py EZY      EZY: the program, built with the feature `parquet`

Those readers that are not at hand are left out; with fewer than two nothing is checked. `pip install duckdb polars pandas pyarrow` brings all.
"""

import importlib.util
import json
import math
import pathlib
import subprocess
import sys
import tempfile

SCENE = "ezyroller/driven"
# the last value is refused: a row without numbers; a method is a word
SWEEP = ["sweep", SCENE, "--until", "5", "--vary", "m0=1:3:0.5", "--vary", "m1=40,46,-1e3", "--vary", "method=dop853,taylor", "--keep", "C.x,max:seat.vx,samples",
         "--every", "0.5", "--part", "7"]
N_CASES = 30


# rows, and the samples of each case
ROWS, SAMPLES = "part-*", "runs/*/case-*"


def of_duckdb(folder, name, files):
    import duckdb

    read = "read_parquet" if name == "parquet" else "read_csv"
    table = duckdb.sql(f"select * from {read}('{folder}/{files}.{name}') order by 1, 2")
    return dict(zip(table.columns, map(list, zip(*table.fetchall()))))


def of_polars(folder, name, files):
    import polars

    pattern = f"{folder}/{files}.{name}"
    if name == "parquet":
        table = polars.read_parquet(pattern)
    elif files == SAMPLES:
        table = polars.read_csv(pattern, infer_schema_length=None)
    else:
        # a part whose runs all failed has no numbers to guess the kind from; sweep.json says it
        columns = json.loads((pathlib.Path(folder) / "sweep.json").read_text())["columns"]
        kinds = {"number": polars.Float64, "count": polars.Int64, "text": polars.String}
        heading = lambda of: f"{of['name']} [{of['unit']}]" if of["unit"] else of["name"]
        table = polars.read_csv(pattern, schema_overrides={heading(of): kinds[of["kind"]] for of in columns})
    return table.sort(table.columns[:2] if files == SAMPLES else "case").to_dict(as_series=False)


def of_pandas(folder, name, files):
    import pandas

    paths = sorted(pathlib.Path(folder).glob(f"{files}.{name}"))
    one = pandas.read_parquet if name == "parquet" else (lambda file: pandas.read_csv(file, float_precision="round_trip"))
    table = pandas.concat([one(path) for path in paths])
    table = table.sort_values(list(table.columns[:2]) if files == SAMPLES else "case")
    return {column: table[column].tolist() for column in table}


READERS = {"duckdb": of_duckdb, "polars": of_polars, "pandas": of_pandas}


def plain(value):
    """What all readers mean by it: nothing is None."""
    if value is None or (isinstance(value, float) and math.isnan(value)) or value == "":
        return None
    return value


def normal(table):
    """Columns without their units, values without kinds of nothing."""
    return {name.rsplit(" [", 1)[0]: [plain(value) for value in values] for name, values in table.items()}


def units_of_parquet(file):
    """Units and the description in the metadata."""
    import pyarrow.parquet

    metadata = pyarrow.parquet.read_metadata(file).metadata
    units = {key.decode()[5:]: value.decode() for key, value in metadata.items() if key.startswith(b"unit.")}
    return units, json.loads(metadata[b"ezy.sweep"])


def main():
    readers = {name: read for name, read in READERS.items() if importlib.util.find_spec(name)}
    if len(readers) < 2:
        print(f"skipped: two readers are needed, and there {'is ' + ', '.join(readers) if readers else 'are none'}")
        sys.exit(1 if sys.argv[1] == "--at-hand" else 0)
    if sys.argv[1] == "--at-hand":
        return
    ezy = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        tables, trajectories = {}, {}
        for name in ("csv", "parquet"):
            out = pathlib.Path(folder) / name
            done = subprocess.run([str(ezy), *SWEEP, "--format", name, "--out", str(out)], capture_output=True, text=True)
            if "built without Parquet" in done.stderr:
                print("skipped: the program was built without Parquet")
                return
            assert done.returncode == 0, done.stderr
            for reader, read in readers.items():
                tables[reader, name] = normal(read(out, name, ROWS))
                trajectories[reader, name] = normal(read(out, name, SAMPLES))
        (first, table), *others = tables.items()
        assert len(table["case"]) == N_CASES and table["case"] == list(range(N_CASES)), table["case"]
        for other, found in others:
            assert found == table, f"{other} and {first} differ: {[name for name in table if found.get(name) != table[name]]}"
        (first, samples), *others = trajectories.items()
        for other, found in others:
            assert found == samples, f"samples by {other} and {first} differ"
        refused = [outcome == "refused" for outcome in table["outcome"]]
        assert sum(refused) == N_CASES // 3 and all((x is None) == is_refused for x, is_refused in zip(table["C.x"], refused))
        # of each case that ran 11 samples
        expected_samples = [case for case in range(N_CASES) if not refused[case] for _ in range(11)]
        assert samples["case"] == expected_samples and samples["t"] == [0.5 * i for i in range(11)] * (N_CASES // 3 * 2), samples["case"]
        # the numbers are those of a run
        case = 8
        arguments = [f"m0={table['m0'][case]}", f"m1={table['m1'][case]}"]
        run = [str(ezy), "run", SCENE, "--until", "5", "--method", table["method"][case], "--json"]
        for argument in arguments:
            run += ["--set", argument]
        end = json.loads(subprocess.run(run, check=True, capture_output=True, text=True).stdout)["state"]
        c = 0.1
        expected = end["bar.x"] + c * math.cos(end["bar.phi"])
        assert abs(table["C.x"][case] - expected) <= 1e-14 * (abs(expected) + 10), (table["C.x"][case], expected)
        told = ""
        if importlib.util.find_spec("pyarrow"):
            units, description = units_of_parquet(pathlib.Path(folder) / "parquet" / "part-000000.parquet")
            assert units == {"m0": "N*m", "m1": "kg", "C.x": "m", "max:seat.vx": "m/s", "end": "s"}, units
            assert (description["model"], description["scene"], description["cases"]) == ("EzyRoller", "driven", N_CASES)
            told = f"; units {units}"
        print(f"{len(tables)} tables of {N_CASES} rows and {len(expected_samples)} samples by {', '.join(readers)} are the same{told}\n0 failed")


if __name__ == "__main__":
    main()
