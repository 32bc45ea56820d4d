"""`python -m interlock`: the command `interlock`, where the folder of commands is not on the path."""

from interlock.cli.main import main

if __name__ == "__main__":
    main()
