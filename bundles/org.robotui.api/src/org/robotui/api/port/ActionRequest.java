package org.robotui.api.port;

import java.util.Map;

/**
 * A task for a robot that takes its time. Cancelling the call cancels the task.
 *
 * @param action the robot's name of the action
 * @param goal the fields of the goal by name: numbers, text, lists, maps; absent fields are zero
 */
public record ActionRequest(String action, Map<String, Object> goal) {}
