use super::DrawnScene;
