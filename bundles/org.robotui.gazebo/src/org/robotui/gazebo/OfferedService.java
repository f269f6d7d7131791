package org.robotui.gazebo;

/**
 * A service that a node of another process answers.
 *
 * @param name of the service
 * @param request the full name of the type of requests
 * @param response likewise of responses; {@code ignition.msgs.Empty} where there are none
 * @param address where it is asked, such as {@code tcp://127.0.0.1:40001}
 * @param socket the identity of the socket there
 * @param process which process it is in
 * @param node which node of the process
 */
public record OfferedService(QualifiedName name, String request, String response, String address, String socket,
    String process, String node) {

  /**
   * Whether no response comes.
   *
   * @return true where the type of responses is that of empty messages
   */
  public boolean isOneWay() {
    return response.equals("ignition.msgs.Empty") || response.equals("gz.msgs.Empty");
  }
}
