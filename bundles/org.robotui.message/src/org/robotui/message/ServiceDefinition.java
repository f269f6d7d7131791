package org.robotui.message;

import java.util.List;
import java.util.Optional;

/**
 * One service type as its definition says it.
 *
 * @param type the full name, such as {@code std_srvs/SetBool}
 * @param text the definition's text as found
 * @param request the part before the line {@code ---}; its type is named {@code <type>Request}
 * @param response the part after it; its type is named {@code <type>Response}
 */
public record ServiceDefinition(String type, String text, MessageDefinition request, MessageDefinition response) {

  private static final int PARTS = 2;
  private static final String REQUEST = "Request";
  private static final String RESPONSE = "Response";

  /** Where services are found by name. */
  @FunctionalInterface
  interface Finder {
    Optional<ServiceDefinition> find(String type) throws DefinitionException;
  }

  /**
   * Reads a definition.
   *
   * @param type the full name
   * @param text the text of the {@code .srv} file
   * @param generation whose definition it is
   * @return the service type
   * @throws DefinitionException if it is no service definition
   */
  public static ServiceDefinition parse(String type, String text, Generation generation) throws DefinitionException {
    List<String> parts = DefinitionParts.of(text);
    if (parts.size() != PARTS) {
      throw new DefinitionException(type,
          "expected one line '---' between request and response, found " + (parts.size() - 1));
    }
    return new ServiceDefinition(type, text, DefinitionParser.parse(type + REQUEST, parts.get(0), generation),
        DefinitionParser.parse(type + RESPONSE, parts.get(1), generation));
  }

  static Optional<MessageDefinition> messageOf(String type, Finder services) throws DefinitionException {
    if (type.endsWith(REQUEST)) {
      String service = type.substring(0, type.length() - REQUEST.length());
      return services.find(service).map(ServiceDefinition::request);
    }
    if (type.endsWith(RESPONSE)) {
      String service = type.substring(0, type.length() - RESPONSE.length());
      return services.find(service).map(ServiceDefinition::response);
    }
    return Optional.empty();
  }
}
