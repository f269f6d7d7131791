package org.robotui.ros.msgs.dynamic_reconfigure;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A group of parameters ({@code dynamic_reconfigure/Group}).
 *
 * @param name       the group
 * @param type       how it is shown; empty for the usual way
 * @param parameters what is in it
 * @param parent     number of the group that holds it; its own for the outermost
 * @param id         number of the group
 */
public record Group(String name, String type, List<ParamDescription> parameters, int parent, int id) {

  /** Between records and bytes. */
  public static final RecordCodec<Group> CODEC =
      RecordCodec.of("dynamic_reconfigure/Group", Group::read, Group::write);

  /** Keeps immutable copies of lists. */
  public Group {
    parameters = List.copyOf(parameters);
  }

  private static Group read(MessageReader in) throws MessageException {
    return new Group(
        in.string("name"),
        in.string("type"),
        in.list("parameters", ParamDescription.CODEC),
        in.int32("parent"),
        in.int32("id"));
  }

  private static void write(Group m, MessageWriter out) {
    out.string(m.name);
    out.string(m.type);
    ParamDescription.CODEC.encodeAll(m.parameters, out);
    out.i32(m.parent);
    out.i32(m.id);
  }
}
