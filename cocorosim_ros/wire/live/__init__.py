"""Topics sent as they come to viewers that connect over a WebSocket, without ROS."""
