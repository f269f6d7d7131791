package org.robotui.message;

/**
 * A service type with all the types it refers to.
 *
 * @param type the full name, such as {@code std_srvs/SetBool}
 * @param md5 the MD5 sum of the whole service as ROS computes it
 * @param request the type of the request
 * @param response the type of the response
 */
public record ServiceSchema(String type, String md5, MessageSchema request, MessageSchema response) {

  /**
   * Puts a type together from its definition and a source of the types it refers to.
   *
   * @param definition the service type
   * @param source where to find message types
   * @return the complete type
   * @throws DefinitionException if a type is missing, broken, recursive, or nested too deeply
   */
  public static ServiceSchema resolve(ServiceDefinition definition, DefinitionSource source)
      throws DefinitionException {
    MessageSchema request = MessageSchema.resolve(definition.request(), source);
    MessageSchema response = MessageSchema.resolve(definition.response(), source);
    return new ServiceSchema(definition.type(), Md5.ofService(request, response), request, response);
  }
}
