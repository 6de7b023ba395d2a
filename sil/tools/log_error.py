"""An error in a user's input, as a sentence with the place."""


class LogError(Exception):
    pass
