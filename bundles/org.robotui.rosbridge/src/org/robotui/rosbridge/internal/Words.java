package org.robotui.rosbridge.internal;

import java.util.LinkedHashMap;
import java.util.Map;
import org.robotui.web.WebPayload;
import org.robotui.web.tree.JsonText;

/** What is said to a bridge. */
public final class Words {

  private Words() {}

  /** A message of the protocol. */
  public static WebPayload of(String op, Object... namesAndValues) {
    Map<String, Object> message = new LinkedHashMap<>();
    message.put("op", op);
    for (int i = 0; i < namesAndValues.length; i += 2) {
      message.put((String) namesAndValues[i], namesAndValues[i + 1]);
    }
    return new WebPayload.Text(JsonText.write(message));
  }
}
