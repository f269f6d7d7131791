package org.robotui.ros.msgs.visualization_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * An entry of the menu of an interactive marker ({@code visualization_msgs/MenuEntry}).
 *
 * @param id          names it, not 0
 * @param parentId    the entry above it; 0 for none
 * @param title       what is read
 * @param command     what is run, for the types that run something
 * @param commandType what happens when it is chosen
 */
public record MenuEntry(long id, long parentId, String title, String command, int commandType) {

  /** The server is told. */
  public static final int FEEDBACK = 0;

  /** Between records and bytes. */
  public static final RecordCodec<MenuEntry> CODEC =
      RecordCodec.of("visualization_msgs/MenuEntry", MenuEntry::read, MenuEntry::write);

  private static MenuEntry read(MessageReader in) throws MessageException {
    return new MenuEntry(
        in.uint32("id"),
        in.uint32("parent_id"),
        in.string("title"),
        in.string("command"),
        in.uint8("command_type"));
  }

  private static void write(MenuEntry m, MessageWriter out) {
    out.i32((int) m.id);
    out.i32((int) m.parentId);
    out.string(m.title);
    out.string(m.command);
    out.u8(m.commandType);
  }
}
