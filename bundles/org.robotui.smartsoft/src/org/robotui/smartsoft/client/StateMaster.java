package org.robotui.smartsoft.client;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.RosValue;
import org.robotui.smartsoft.internal.SmartStatus;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;

/** Reads and changes the main state of a component, such as {@code Neutral} or {@code Active}. All of it blocks. */
public final class StateMaster {

  /** The request of this pattern, by which its services are known. */
  public static final String REQUEST = "SmartACE::smartStateRequest";
  /** Its answer. */
  public static final String RESPONSE = "SmartACE::smartStateResponse";

  private static final int SET = 1;
  private static final int CURRENT = 2;
  private static final int MAIN_STATES = 3;
  private static final int SUB_STATES = 4;

  private final QueryClient client;
  private final CommType request;
  private final CommType response;
  private final Duration patience;

  /**
   * Of a service.
   *
   * @param client connected to the state of a component
   * @param types with those of this pattern
   * @param patience how long an answer may take; a component answers a change of state when it has changed
   */
  public StateMaster(QueryClient client, CommTypes types, Duration patience) {
    this.client = client;
    this.request = types.get(REQUEST);
    this.response = types.get(RESPONSE);
    this.patience = patience;
  }

  /**
   * The state in which the component is.
   *
   * @return its main state
   * @throws IOException where it does not say
   */
  public String current() throws IOException {
    List<String> states = ask(CURRENT, "");
    if (states.isEmpty()) {
      throw new IOException("the component does not say in which state it is");
    }
    return states.getLast();
  }

  /**
   * All states in which it can be.
   *
   * @return main states
   * @throws IOException where it does not say
   */
  public List<String> all() throws IOException {
    return ask(MAIN_STATES, "");
  }

  /**
   * The parts that are active in a main state.
   *
   * @param state a main state
   * @return sub states
   * @throws IOException where it does not say
   */
  public List<String> parts(String state) throws IOException {
    return ask(SUB_STATES, state);
  }

  /**
   * Changes the state, and waits until it has changed.
   *
   * @param state a main state
   * @throws IOException where it does not change
   */
  public void change(String state) throws IOException {
    ask(SET, state);
  }

  private List<String> ask(int command, String state) throws IOException {
    try {
      DynamicMessage answer = response.read(
          client.query(request.bytes(Map.of("command", command, "state_name", state)), patience));
      int status = (int) answer.number("status").orElseThrow();
      if (status != SmartStatus.OK) {
        throw new IOException("the component refuses: " + SmartStatus.text(status));
      }
      return answer.field("state_list").filter(RosValue.Texts.class::isInstance)
          .map(list -> List.copyOf(((RosValue.Texts) list).values())).orElse(List.of());
    } catch (MessageException e) {
      throw new IOException("the state cannot be read: " + e.getMessage(), e);
    }
  }
}
