package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * The state of a group of parameters ({@code dynamic_reconfigure/GroupState}).
 *
 * @param name   the group
 * @param state  whether it is shown open
 * @param id     number of the group
 * @param parent number of the group that holds it; its own for the outermost
 */
public record GroupState(String name, boolean state, int id, int parent) {

  /** Between records and bytes. */
  public static final RecordCodec<GroupState> CODEC =
      RecordCodec.of("dynamic_reconfigure/GroupState", GroupState::read, GroupState::write);

  private static GroupState read(MessageReader in) throws MessageException {
    return new GroupState(in.string("name"), in.bool("state"), in.int32("id"), in.int32("parent"));
  }

  private static void write(GroupState m, MessageWriter out) {
    out.string(m.name);
    out.bool(m.state);
    out.i32(m.id);
    out.i32(m.parent);
  }
}
