package org.robotui.smartsoft.client;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;

/** Sends parameters to a component. They cannot be read. All of it blocks. */
public final class ParameterMaster {

  /** The request of this pattern, by which its services are known. */
  public static final String REQUEST = "CommParameter::CommParameterRequest";
  /** Its answer. */
  public static final String RESPONSE = "CommParameter::CommParameterResponse";

  private static final String SLOT = "slot";

  private final QueryClient client;
  private final CommType request;
  private final CommType response;
  private final Duration patience;

  /** What a component says to a parameter. The order is that of the numbers on the wire. */
  public enum Response {
    /** It has no time for it now. */
    BUSY,
    /** It is no parameter of this component, or its values do not fit. */
    INVALID,
    /** It was taken. */
    OK
  }

  /**
   * Of a service.
   *
   * @param client connected to the parameters of a component
   * @param types with those of this pattern
   * @param patience how long an answer may take
   */
  public ParameterMaster(QueryClient client, CommTypes types, Duration patience) {
    this.client = client;
    this.request = types.get(REQUEST);
    this.response = types.get(RESPONSE);
    this.patience = patience;
  }

  /**
   * Sends a parameter.
   *
   * @param name such as {@code CommNavigationObjects.CdlParameter.SETGOALMODE}, or {@code COMMIT}
   * @param values in their order
   * @return what the component says
   * @throws IOException where it says nothing
   */
  public Response send(String name, List<String> values) throws IOException {
    List<Map<String, Object>> items = new ArrayList<>();
    items.add(item(SLOT, name));
    for (int i = 0; i < values.size(); i++) {
      items.add(item(Integer.toString(i + 1), values.get(i)));
    }
    try {
      int answer = (int) response.read(client.query(request.bytes(Map.of("items", items)), patience))
          .number("response").orElseThrow();
      if (answer < 0 || answer >= Response.values().length) {
        throw new IOException("the component answers with " + answer + ", which stands for nothing");
      }
      return Response.values()[answer];
    } catch (MessageException e) {
      throw new IOException("the answer cannot be read: " + e.getMessage(), e);
    }
  }

  private static Map<String, Object> item(String key, String value) {
    return Map.of("key", key, "values", List.of(value));
  }
}
