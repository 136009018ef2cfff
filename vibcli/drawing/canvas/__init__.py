"""What a drawing is made of, and the media that show it."""
