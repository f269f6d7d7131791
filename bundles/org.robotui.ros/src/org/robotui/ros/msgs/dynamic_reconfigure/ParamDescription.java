package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Describes a parameter ({@code dynamic_reconfigure/ParamDescription}).
 *
 * @param name        the parameter
 * @param type        {@code bool}, {@code int}, {@code double} or {@code str}
 * @param level       bits the server hears of when it changes
 * @param description for a user
 * @param editMethod  the choices it has, as the text of a Python dictionary; empty if it has none
 */
public record ParamDescription(String name, String type, long level, String description, String editMethod) {

  /** Between records and bytes. */
  public static final RecordCodec<ParamDescription> CODEC =
      RecordCodec.of("dynamic_reconfigure/ParamDescription", ParamDescription::read, ParamDescription::write);

  private static ParamDescription read(MessageReader in) throws MessageException {
    return new ParamDescription(
        in.string("name"),
        in.string("type"),
        in.uint32("level"),
        in.string("description"),
        in.string("edit_method"));
  }

  private static void write(ParamDescription m, MessageWriter out) {
    out.string(m.name);
    out.string(m.type);
    out.i32((int) m.level);
    out.string(m.description);
    out.string(m.editMethod);
  }
}
