"""What is wrong with what a user gave or with what was found, as a sentence with the place."""


class CampaignError(Exception):
    pass
