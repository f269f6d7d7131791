package org.robotui.message.ros.visualization_msgs;

import org.robotui.message.MessageType;

/**
 * An entry of the menu of an interactive marker ({@code visualization_msgs/MenuEntry}).
 *
 * @param id names it, not 0
 * @param parentId the entry above it; 0 for none
 * @param title what is read
 * @param command what is run, for the types that run something
 * @param commandType what happens when it is chosen
 */
@MessageType("visualization_msgs/MenuEntry")
public record MenuEntry(long id, long parentId, String title, String command, int commandType) {

  /** The server is told. */
  public static final int FEEDBACK = 0;
}
