package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.message.MessageType;

/**
 * The state of a group of parameters ({@code dynamic_reconfigure/GroupState}).
 *
 * @param name the group
 * @param state whether it is shown open
 * @param id number of the group
 * @param parent number of the group that holds it; its own for the outermost
 */
@MessageType("dynamic_reconfigure/GroupState")
public record GroupState(String name, boolean state, int id, int parent) {}
