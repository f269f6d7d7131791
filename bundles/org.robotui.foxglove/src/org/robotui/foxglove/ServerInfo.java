package org.robotui.foxglove;

import java.util.List;
import java.util.Set;

/**
 * What a server says of itself.
 *
 * @param name its name
 * @param capabilities what it can, such as {@code clientPublish}
 * @param encodings of messages that it takes
 * @param session changes when the server was started anew; may be empty
 */
public record ServerInfo(String name, Set<String> capabilities, List<String> encodings, String session) {

  /** Takes messages of clients. */
  public static final String CLIENT_PUBLISH = "clientPublish";
  /** Has parameters. */
  public static final String PARAMETERS = "parameters";
  /** Says when parameters change. */
  public static final String PARAMETERS_SUBSCRIBE = "parametersSubscribe";
  /** Says its time. */
  public static final String TIME = "time";
  /** Can be asked. */
  public static final String SERVICES = "services";
  /** Says who publishes and subscribes what. */
  public static final String CONNECTION_GRAPH = "connectionGraph";

  /** Copies the collections. */
  public ServerInfo {
    capabilities = Set.copyOf(capabilities);
    encodings = List.copyOf(encodings);
  }

  /**
   * Whether it can something.
   *
   * @param capability one of its words
   * @return true where it says so
   */
  public boolean can(String capability) {
    return capabilities.contains(capability);
  }
}
