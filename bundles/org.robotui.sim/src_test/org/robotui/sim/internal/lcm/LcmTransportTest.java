package org.robotui.sim.internal.lcm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.SubscriptionOptions;

class LcmTransportTest {
  private static final ThreadFactory THREADS = task -> Thread.ofPlatform().daemon().unstarted(task);

  @Test
  void withoutMulticastAServerCarriesTheMessages() throws Exception {
    BlockingQueue<Byte> heard = new LinkedBlockingQueue<>();
    try (LcmTransport air =
        LcmTransport.orServed(LcmUrl.of("udpm://239.255.76.67:7667?ttl=0&interface=nosuch0"), THREADS)) {
      assertEquals("tcpq", air.lcm().url().provider());
      assertTrue(air.server().isPresent());
      try (Lcm client = Lcm.open(air.lcm().url(), LcmOptions.standard(THREADS))) {
        client.subscribe("X", SubscriptionOptions.direct(), message -> heard.add(message.data().get()));
        Optional<Byte> first = Optional.empty();
        for (int i = 0; i < 200 && first.isEmpty(); i++) {
          air.lcm().publish("X", ByteBuffer.wrap(new byte[]{7}));
          first = Optional.ofNullable(heard.poll(50, TimeUnit.MILLISECONDS));
        }
        assertEquals(Optional.of((byte) 7), first);
      }
    }
  }

  @Test
  void whatIsWrittenIsTakenAsItIs() throws Exception {
    try (LcmTransport air = LcmTransport.open(Optional.of(LcmUrl.of("memq://")), THREADS)) {
      assertEquals("memq", air.lcm().url().provider());
      assertFalse(air.server().isPresent());
      assertNotNull(air.lcm().state());
    }
  }
}
