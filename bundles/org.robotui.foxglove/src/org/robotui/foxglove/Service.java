package org.robotui.foxglove;

/**
 * What a server can be asked.
 *
 * @param id by which the server knows it
 * @param name its name
 * @param type the name of its type, such as {@code std_srvs/srv/SetBool}
 * @param request what is asked
 * @param response what is answered
 */
public record Service(long id, String name, String type, Form request, Form response) {

  /**
   * The form of requests or responses.
   *
   * @param encoding of the messages; empty where the server did not say, as older ones do
   * @param type the name of the schema
   * @param schemaEncoding of the schema
   * @param schema the schema
   */
  public record Form(String encoding, String type, String schemaEncoding, String schema) {}
}
