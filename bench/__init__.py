"""What is measured by hand: start-up, and the findings of each rule over real repositories."""
