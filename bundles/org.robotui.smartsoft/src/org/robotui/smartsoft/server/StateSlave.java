package org.robotui.smartsoft.server;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.client.StateMaster;
import org.robotui.smartsoft.internal.SmartStatus;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;

/** Answers for the main state of a component, which changes at once. */
public final class StateSlave implements QueryServer.Handler {

  private static final int SET = 1;
  private static final int CURRENT = 2;
  private static final int MAIN_STATES = 3;

  private final CommType request;
  private final CommType response;
  private final List<String> states;
  private final Consumer<String> changed;
  private String current;

  /**
   * In the first of its states.
   *
   * @param types with those of this pattern
   * @param states all main states, at least one
   * @param changed is told each change, on the thread of the client
   */
  public StateSlave(CommTypes types, List<String> states, Consumer<String> changed) {
    this.request = types.get(StateMaster.REQUEST);
    this.response = types.get(StateMaster.RESPONSE);
    this.states = List.copyOf(states);
    this.changed = changed;
    this.current = states.getFirst();
  }

  @Override
  public synchronized ByteBuffer answer(ByteBuffer asked) throws MessageException {
    DynamicMessage said = request.read(asked);
    String name = said.text("state_name").orElse("");
    return switch ((int) said.number("command").orElse(0)) {
      case SET -> answer(change(name) ? SmartStatus.OK : SmartStatus.NOT_ALLOWED, List.of());
      case CURRENT -> answer(SmartStatus.OK, List.of(current));
      case MAIN_STATES -> answer(SmartStatus.OK, states);
      default -> answer(SmartStatus.UNKNOWN_STATE, List.of());
    };
  }

  private boolean change(String name) {
    if (!states.contains(name)) {
      return false;
    }
    current = name;
    changed.accept(name);
    return true;
  }

  private ByteBuffer answer(int status, List<String> list) throws MessageException {
    return response.bytes(Map.of("status", status, "state_list", list));
  }
}
