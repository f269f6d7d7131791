package org.robotui.lcm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** URLs, and what is said of wrong ones before anything is opened. */
class LcmUrlTest {

  @Test
  void partsAreRead() {
    assertEquals(new LcmUrl("udpm", "239.1.2.3:7000", Map.of("ttl", "1", "recv_buf_size", "9")),
        LcmUrl.of("udpm://239.1.2.3:7000?ttl=1&recv_buf_size=9"));
    assertEquals(new LcmUrl("file", "/a/b.lcmlog", Map.of("speed", "2")), LcmUrl.of("file:///a/b.lcmlog?speed=2"));
    assertEquals("udpm://?recv_buf_size=9&ttl=1", LcmUrl.of("udpm://?ttl=1&recv_buf_size=9").toString());
  }

  @Test
  void theEnvironmentDecidesAndOtherwiseThisMachineOnly() {
    assertEquals("memq://", LcmUrl.of(Map.of("LCM_DEFAULT_URL", "memq://")).toString());
    assertEquals(LcmUrl.DEFAULT, LcmUrl.of(Map.of()).toString());
    assertEquals(LcmUrl.DEFAULT, LcmUrl.of(Map.of("LCM_DEFAULT_URL", " ")).toString());
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> LcmUrl.of(Map.of("LCM_DEFAULT_URL", "here")));
    assertTrue(e.getMessage().startsWith("LCM_DEFAULT_URL: 'here' is no LCM URL; write for example udpm://"),
        e.getMessage());
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', textBlock = """
      udpm://10.0.0.1:7667               | '10.0.0.1:7667' is no multicast address with a port
      udpm://239.255.76.67:70000         | is no multicast address with a port
      udpm://239.255.76.67:7667?ttl=300  | ttl=300 is no number from 0 to 255
      udpm://robots.example:7667         | is no multicast address with a port
      tcpq://nowhere:0                   | 'nowhere:0' is no host with a port; write for example tcpq://127.0.0.1:7700
      file://                            | no file is named
      file://x.lcmlog?mode=x             | mode=x is none of r, w, a
      file://x.lcmlog?speed=-1           | speed=-1 is no factor
      file://x.lcmlog?start_timestamp=a  | start_timestamp=a is no number of microseconds
      dds://x                            | LCM has no provider 'dds'
      udpm://?ttl                        | 'ttl' in 'udpm://?ttl' is no option; write NAME=VALUE
      """)
  void wrongOnesAreRefusedAtOnce(String url, String reason) {
    LcmOptions options = LcmOptions.standard(new TestThreads());
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> Lcm.open(LcmUrl.of(url), options).close());
    assertTrue(e.getMessage().contains(reason), e.getMessage());
  }
}
