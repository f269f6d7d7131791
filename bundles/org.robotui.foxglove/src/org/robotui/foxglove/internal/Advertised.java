package org.robotui.foxglove.internal;

import java.util.Map;
import java.util.Set;
import org.robotui.foxglove.ServerChannel;
import org.robotui.foxglove.ServerInfo;
import org.robotui.foxglove.Service;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/** Reads what a server says of itself, its channels and its services. */
public final class Advertised {

  private Advertised() {}

  /** Of the message {@code serverInfo}. */
  public static ServerInfo info(Map<String, Object> message) throws TreeException {
    return new ServerInfo(Trees.optionalText(message, "name").orElse(""),
        Set.copyOf(Trees.texts(message, "capabilities")), Trees.texts(message, "supportedEncodings"),
        Trees.optionalText(message, "sessionId").orElse(""));
  }

  /** An item of the message {@code advertise}. */
  public static ServerChannel channel(Map<String, Object> item) throws TreeException {
    return new ServerChannel(Trees.whole(item, "id"), Trees.text(item, "topic"), Trees.text(item, "encoding"),
        Trees.text(item, "schemaName"), Trees.optionalText(item, "schemaEncoding").orElse(""),
        Trees.optionalText(item, "schema").orElse(""));
  }

  /** An item of the message {@code advertiseServices}. */
  public static Service service(Map<String, Object> item) throws TreeException {
    return new Service(Trees.whole(item, "id"), Trees.text(item, "name"), Trees.text(item, "type"),
        form(item, "request"), form(item, "response"));
  }

  /** Older servers give a schema alone. */
  private static Service.Form form(Map<String, Object> item, String name) throws TreeException {
    if (!(item.get(name) instanceof Map<?, ?>)) {
      return new Service.Form("", "", "", Trees.optionalText(item, name + "Schema").orElse(""));
    }
    Map<String, Object> form = Trees.object(item.get(name));
    return new Service.Form(Trees.optionalText(form, "encoding").orElse(""),
        Trees.optionalText(form, "schemaName").orElse(""), Trees.optionalText(form, "schemaEncoding").orElse(""),
        Trees.optionalText(form, "schema").orElse(""));
  }
}
