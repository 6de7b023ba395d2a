"""What is wrong with what a user gave, as a sentence with the place."""


class LogError(Exception):
    pass
