package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * A change and what it leads from and to ({@code lifecycle_msgs/TransitionDescription}).
 *
 * @param transition the change
 * @param startState from
 * @param goalState to
 */
@MessageType("lifecycle_msgs/TransitionDescription")
public record WireTransitionDescription(WireTransition transition, WireState startState, WireState goalState) {}
