package org.robotui.player.layout;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.player.wire.MessageType;

/**
 * An interface: the messages that devices of one kind understand.
 *
 * @param code its number
 * @param name its name, such as {@code position2d}
 * @param messages its messages
 * @param structs its structures by name, with those of all interfaces
 */
public record InterfaceLayout(int code, String name, List<MessageLayout> messages, Map<String, StructLayout> structs) {

  /** Keeps copies. */
  public InterfaceLayout {
    messages = List.copyOf(messages);
    structs = Map.copyOf(structs);
  }

  /**
   * Finds a message by its number.
   *
   * @param type the type; for ACK and NACK the request is found
   * @param subtype the number
   * @return empty if there is no such message
   */
  public Optional<MessageLayout> message(MessageType type, int subtype) {
    MessageType declared = type == MessageType.ACK || type == MessageType.NACK ? MessageType.REQUEST : type;
    return messages.stream().filter(each -> each.type() == declared && each.subtype() == subtype).findFirst();
  }

  /**
   * Finds a message by its name.
   *
   * @param type the type
   * @param wanted the name
   * @return empty if there is no such message
   */
  public Optional<MessageLayout> message(MessageType type, String wanted) {
    return messages.stream().filter(each -> each.type() == type && each.name().equals(wanted)).findFirst();
  }
}
