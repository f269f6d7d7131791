package org.robotui.core.internal.facts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SecretMaskTest {
  @ParameterizedTest
  @ValueSource(strings = {
      "  password: hunter2", "password: \"hunter2\"", "- token: hunter2", "api_key: hunter2", "robot.auth-key=hunter2",
      "{host: keira, token: hunter2}", "{\"token\": \"hunter2\", \"a\": 1}", "PGPASSWORD=hunter2",
      "db_passwd : hunter2",
      "uri: ws://anna:hunter2@keira:9090", "uri: ws://keira:9090/?token=hunter2&x=1",
      "see http://keira/?key=hunter2 for",
      "Authorization: Bearer hunter2hunter2", "sent 'Bearer hunter2hunter2' to it", "argument -Dfoo.secret=hunter2",
      "12:00 WARN login with password=hunter2, user=anna", "password: two words hunter2", "client_secret='hunter2'"})
  void aSecretIsMasked(String line) {
    String masked = SecretMask.masked(line);
    assertFalse(masked.contains("hunter2"), masked);
    assertTrue(masked.contains(SecretMask.MASK), masked);
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
      "{host: keira, token: abc, port: 9}|{host: keira, token: ***, port: 9}",
      "uri: ws://anna:abc@keira:9090/x|uri: ws://***@keira:9090/x",
      "uri: ws://keira/?token=abc&x=1|uri: ws://keira/?token=***&x=1"})
  void whatStandsAroundStays(String line, String expected) {
    assertEquals(expected + "\n", SecretMask.masked(line));
  }

  @ParameterizedTest
  @ValueSource(strings = {"host: keira", "uri: ws://keira:9090", "when: battery charge < 0.2",
      "  at org.robotui.Token.read(Token.java:12)",
      "key: value", "mail to anna@keira", "keyboard: us", "ROS_MASTER_URI=http://127.0.0.1:11311"})
  void whatIsNoSecretStays(String line) {
    assertEquals(line + "\n", SecretMask.masked(line));
  }

  @Test
  void aSecretOfSeveralLinesIsMaskedToItsEnd() {
    String masked = SecretMask.masked("""
        rfics:
          base:
            password: |
              abc

              def
            host: keira
        pem: x
        -----BEGIN RSA PRIVATE KEY-----
        MIIE
        -----END RSA PRIVATE KEY-----
        views: []
        """);

    assertEquals("""
        rfics:
          base:
            password: ***
              ***

              ***
            host: keira
        pem: x
        ***
        ***
        ***
        views: []
        """, masked);
  }

  @Test
  void aLineWithoutAnEndTakesNoTimeWithoutAnEnd() {
    String masked = SecretMask.masked("token".repeat(400_000) + "\npassword=\"" + "\\\"".repeat(400_000));
    assertTrue(masked.length() < 100_000);
  }
}
