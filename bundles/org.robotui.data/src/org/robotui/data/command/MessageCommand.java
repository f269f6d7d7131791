package org.robotui.data.command;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.robotui.data.Conflation;
import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.Late;

/**
 * One message of any type, said on a topic by its name. Absent fields are zero or empty.
 *
 * @param topic the robot's name of the topic
 * @param type the robot's name of the type
 * @param fields the fields by name: Boolean, Number, String, List or Map of these; times as Long, nanoseconds
 */
@Delivery(conflation = Conflation.EVENT, late = Late.NONE, expires = false)
public record MessageCommand(String topic, String type, Map<String, Object> fields) implements Data {
  /**
   * Copies the fields.
   *
   * @param topic the topic
   * @param type the type
   * @param fields the fields by name
   */
  public MessageCommand {
    fields = Collections.unmodifiableMap(new LinkedHashMap<>(fields));
  }
}
