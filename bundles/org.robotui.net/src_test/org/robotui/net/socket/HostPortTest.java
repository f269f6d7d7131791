package org.robotui.net.socket;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class HostPortTest {

  @ParameterizedTest
  @CsvSource({"http://my_robot:11311/, my_robot, 11311, my_robot:11311", "http://[::1]:80, ::1, 80, [::1]:80"})
  void urisAreRead(String uri, String host, int port, String text) {
    HostPort read = HostPort.ofUri(uri, "http");
    assertEquals(new HostPort(host, port), read);
    assertEquals(text, read.toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "http://", "http://robot", "http://robot:0", "http://robot:65536", "http://:80",
      "rosrpc://robot:80"})
  void whatNamesNoHostAndPortIsRefused(String uri) {
    assertThrows(IllegalArgumentException.class, () -> HostPort.ofUri(uri, "http"));
  }

  @Test
  void aHostIsNotLongerThanNamesMayBe() {
    assertThrows(IllegalArgumentException.class, () -> new HostPort("a".repeat(256), 1));
  }

  @Test
  void variablesNameAHostAPortOrBoth() {
    assertEquals(new HostPort("robot", 1381), HostPort.ofVariable("CENTRALHOST", "robot", 1381));
    assertEquals(new HostPort("robot", 7), HostPort.ofVariable("CENTRALHOST", "robot:7", 1381));
    assertEquals(new HostPort("localhost", 7), HostPort.ofVariable("CENTRALHOST", ":7", 1381));
    IllegalArgumentException wrong =
        assertThrows(IllegalArgumentException.class, () -> HostPort.ofVariable("CENTRALHOST", "robot:x", 1381));
    assertEquals("CENTRALHOST is 'robot:x'; write HOST or HOST:PORT", wrong.getMessage());
  }
}
