package org.robotui.ros.internal.xmlrpc;

import java.time.Duration;

/**
 * What an XML-RPC client or server waits for and accepts at most.
 *
 * @param connect until a connection stands
 * @param message until a message is there as a whole
 * @param idle between two messages of a connection
 * @param maxBody bytes of one message
 * @param maxBodies bytes of the large messages of all connections of a server together
 * @param maxConnections of a server
 */
public record XmlRpcLimits(Duration connect, Duration message, Duration idle, int maxBody, long maxBodies,
    int maxConnections) {

  public static XmlRpcLimits standard() {
    return new XmlRpcLimits(Duration.ofSeconds(3), Duration.ofSeconds(10), Duration.ofSeconds(60), 16 << 20, 48L << 20,
        512);
  }

  public XmlRpcLimits withMessage(Duration time) {
    return new XmlRpcLimits(connect, time, idle, maxBody, maxBodies, maxConnections);
  }
}
