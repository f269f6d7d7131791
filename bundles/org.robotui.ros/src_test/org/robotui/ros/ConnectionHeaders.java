package org.robotui.ros;

import org.robotui.ros.internal.tcpros.ConnectionHeader;

/** Headers of scripted peers. */
final class ConnectionHeaders {

  private ConnectionHeaders() {}

  static byte[] error(String reason) {
    return ConnectionHeader.error("/liar", reason).encode();
  }

  static byte[] subscriber(String topic, String md5) {
    return ConnectionHeader.of("/liar").with("topic", topic).with("md5sum", md5).with("type", "std_msgs/String")
        .encode();
  }

  static byte[] client(String service, String md5) {
    return ConnectionHeader.of("/liar").with("service", service).with("md5sum", md5).with("persistent", "1").encode();
  }
}
