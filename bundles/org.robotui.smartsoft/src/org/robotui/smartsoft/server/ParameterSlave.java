package org.robotui.smartsoft.server;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.RosValue;
import org.robotui.smartsoft.client.ParameterMaster;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;

/** Takes parameters for a component. */
public final class ParameterSlave implements QueryServer.Handler {

  private static final String SLOT = "slot";

  private final CommType request;
  private final CommType response;
  private final Handler handler;

  /** Takes parameters, on the thread of each client. */
  @FunctionalInterface
  public interface Handler {

    /**
     * A parameter has come.
     *
     * @param name of the parameter
     * @param values in their order
     * @return what its sender is told
     */
    ParameterMaster.Response parameter(String name, List<String> values);
  }

  /**
   * Of a component.
   *
   * @param types with those of this pattern
   * @param handler takes parameters
   */
  public ParameterSlave(CommTypes types, Handler handler) {
    this.request = types.get(ParameterMaster.REQUEST);
    this.response = types.get(ParameterMaster.RESPONSE);
    this.handler = handler;
  }

  @Override
  public ByteBuffer answer(ByteBuffer asked) throws MessageException {
    String name = "";
    List<String> values = new ArrayList<>();
    if (request.read(asked).field("items").orElseThrow() instanceof RosValue.Messages items) {
      for (DynamicMessage item : items.values()) {
        String value = item.text("values[0]").orElse("");
        if (item.text("key").orElse("").equals(SLOT)) {
          name = value;
        } else {
          values.add(value);
        }
      }
    }
    return response.bytes(Map.of("response", handler.parameter(name, values).ordinal()));
  }
}
