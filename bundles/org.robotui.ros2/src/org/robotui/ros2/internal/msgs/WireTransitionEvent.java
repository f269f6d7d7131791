package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * A change that happened ({@code lifecycle_msgs/TransitionEvent}).
 *
 * @param timestamp when, by the clock of the node
 * @param transition the change
 * @param startState from
 * @param goalState to
 */
@MessageType("lifecycle_msgs/TransitionEvent")
public record WireTransitionEvent(long timestamp, WireTransition transition, WireState startState,
    WireState goalState) {}
