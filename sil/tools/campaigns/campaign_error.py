"""An error in a user's input or in a result, as a sentence with the place."""


class CampaignError(Exception):
    pass
