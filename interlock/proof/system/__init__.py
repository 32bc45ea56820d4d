"""The transition system: controller, plant, and how their clocks go together; what is known at the restart."""
