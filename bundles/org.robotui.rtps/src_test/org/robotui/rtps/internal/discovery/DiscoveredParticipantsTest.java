package org.robotui.rtps.internal.discovery;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.robotui.rtps.DiscoveryListener;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.ParticipantLimits;
import org.robotui.rtps.Locators;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.ProtocolVersion;
import org.robotui.rtps.Qos;
import org.robotui.rtps.VendorId;

class DiscoveredParticipantsTest {

  private static final long SECOND = 1_000_000_000L;

  private static final ParticipantLimits SMALL = new ParticipantLimits(40, 5, 1000, 1000, 1000);

  private final DiscoveredParticipants discovered = new DiscoveredParticipants(3, SMALL);

  private final List<String> told = new ArrayList<>();

  private final class Ear implements DiscoveryListener {
    @Override
    public void participantFound(ParticipantInfo participant) {
      told.add("found " + participant.name());
    }

    @Override
    public void participantChanged(ParticipantInfo participant) {
      told.add("changed " + participant.name());
    }

    @Override
    public void participantLost(ParticipantInfo participant, String reason) {
      told.add("lost " + participant.name() + ": " + reason);
    }

    @Override
    public void endpointFound(EndpointInfo endpoint) {
      told.add("found " + endpoint.topic());
    }

    @Override
    public void endpointChanged(EndpointInfo endpoint) {
      told.add("changed " + endpoint.topic());
    }

    @Override
    public void endpointLost(EndpointInfo endpoint, String reason) {
      told.add("lost " + endpoint.topic() + ": " + reason);
    }
  }

  private static GuidPrefix prefix(int number) {
    return new GuidPrefix(7, number);
  }

  private static InetAddress host(int number) {
    try {
      return InetAddress.getByAddress(new byte[]{10, 0, 0, (byte) number});
    } catch (UnknownHostException e) {
      throw new IllegalStateException(e);
    }
  }

  private static ParticipantInfo info(int number, String name, int domain, Duration lease) {
    return new ParticipantInfo(Guid.participant(prefix(number)), VendorId.FAST_DDS, ProtocolVersion.V2_3, name,
        OptionalInt.of(domain), lease, BuiltIn.OURS, Locators.NONE, Locators.NONE, ByteBuffer.allocate(0));
  }

  private Admission announce(int number, String name, long now) {
    return discovered.announced(info(number, name, 3, Duration.ofSeconds(10)), prefix(number), host(1), now);
  }

  private static EndpointInfo endpoint(int participant, int key, String topic) {
    Guid guid = new Guid(prefix(participant), EntityId.user(key, EndpointKind.WRITER, false));
    return new EndpointInfo(guid, EndpointKind.WRITER, topic, "t", Qos.standard(), ByteBuffer.allocate(0),
        Locators.NONE, false);
  }

  @Test
  void participants_and_endpoints_come_change_and_go_in_order() {
    discovered.addListener(new Ear());

    assertEquals(new Admission.Found(), announce(1, "a", 0));
    assertEquals(new Admission.Known(), announce(1, "a", 1));
    assertEquals(new Admission.Found(), discovered.endpointAnnounced(endpoint(1, 1, "x"), prefix(1)));
    assertEquals(new Admission.Known(), discovered.endpointAnnounced(endpoint(1, 1, "x"), prefix(1)));
    assertEquals(new Admission.Changed(), discovered.endpointAnnounced(endpoint(1, 1, "y"), prefix(1)));
    discovered.endpointAnnounced(endpoint(1, 2, "z"), prefix(1));
    assertEquals(new Admission.Changed(), announce(1, "b", 2));
    discovered.endpointLeft(endpoint(1, 1, "y").guid(), prefix(1), "it said so");
    discovered.left(Guid.participant(prefix(1)), prefix(1), "it said so");

    assertEquals(List.of("found a", "found x", "changed y", "found z", "changed b", "lost y: it said so",
        "lost z: its participant: it said so", "lost b: it said so"), told);
    assertEquals(List.of(), discovered.participants());
    assertEquals(List.of(), discovered.endpoints());
  }

  @Test
  void who_is_not_heard_for_its_lease_is_gone() {
    discovered.addListener(new Ear());
    announce(1, "a", 0);
    announce(2, "b", 0);
    discovered.heard(prefix(2), 8 * SECOND);
    discovered.heard(prefix(99), 8 * SECOND);

    assertEquals(SECOND, discovered.expire(9 * SECOND));
    assertEquals(8 * SECOND, discovered.expire(10 * SECOND));
    assertEquals(List.of("found a", "found b", "lost a: not heard for its lease of 10000 ms"), told);
    assertEquals(Long.MAX_VALUE, discovered.expire(18 * SECOND));
  }

  @Test
  void leases_may_have_no_end_or_be_too_short_to_mean_anything() {
    discovered.announced(info(1, "ever", 3, Qos.INFINITE), prefix(1), host(1), 0);
    discovered.announced(info(2, "never", 3, Duration.ZERO), prefix(2), host(1), 0);

    assertEquals(SECOND / 2, discovered.expire(SECOND / 2));
    assertEquals(Long.MAX_VALUE, discovered.expire(SECOND));
    assertEquals(1, discovered.participants().size());
  }

  @Test
  void a_late_listener_is_told_what_is_there_and_a_removed_one_nothing() {
    announce(1, "a", 0);
    discovered.endpointAnnounced(endpoint(1, 1, "x"), prefix(1));
    Ear ear = new Ear();
    discovered.addListener(ear);
    discovered.removeListener(ear);
    announce(2, "b", 0);

    assertEquals(List.of("found a", "found x"), told);
  }

  @Test
  void a_listener_may_ask_and_change_and_throw_and_the_others_hear_all_in_order() {
    discovered.addListener(new DiscoveryListener() {
      @Override
      public void participantFound(ParticipantInfo participant) {
        discovered.endpointAnnounced(endpoint(1, 1, "x"), prefix(1));
        throw new IllegalStateException("as listeners do");
      }
    });
    discovered.addListener(new Ear());
    announce(1, "a", 0);

    assertEquals(List.of("found a", "found x"), told);
  }

  @Test
  void nobody_says_anything_about_others() {
    announce(1, "a", 0);
    announce(2, "b", 0);
    discovered.endpointAnnounced(endpoint(1, 1, "x"), prefix(1));

    assertInstanceOf(Admission.Refused.class, discovered.announced(info(1, "forged", 3, Qos.INFINITE), prefix(2),
        host(2), 0));
    assertInstanceOf(Admission.Refused.class, discovered.endpointAnnounced(endpoint(1, 2, "forged"), prefix(2)));
    discovered.left(Guid.participant(prefix(1)), prefix(2), "forged");
    discovered.endpointLeft(endpoint(1, 1, "x").guid(), prefix(2), "forged");

    assertEquals(2, discovered.participants().size());
    assertEquals(List.of("x"), discovered.endpoints().stream().map(EndpointInfo::topic).toList());
  }

  @Test
  void other_domains_and_endpoints_of_nobody_are_refused_with_a_reason() {
    Admission other = discovered.announced(info(1, "a", 4, Qos.INFINITE), prefix(1), host(1), 0);
    Admission nobody = discovered.endpointAnnounced(endpoint(1, 1, "x"), prefix(1));

    assertTrue(other.toString().contains("is of domain 4, not of 3"), other::toString);
    assertTrue(nobody.toString().contains("its participant is not known"), nobody::toString);
  }

  @Test
  void one_machine_that_floods_leaves_room_for_others() {
    for (int i = 0; i < 10_000; i++) {
      Admission outcome = announce(i, "flood", 0);
      assertEquals(i < 10, outcome instanceof Admission.Found, outcome::toString);
    }
    Admission other = discovered.announced(info(20_000, "robot", 3, Qos.INFINITE), prefix(20_000), host(2), 0);

    assertEquals(new Admission.Found(), other);
    assertEquals(11, discovered.participants().size());
  }

  @Test
  void who_was_silent_for_long_makes_room_whatever_its_lease_is() {
    for (int i = 0; i < 10; i++) {
      discovered.announced(info(i, "liar " + i, 3, Qos.INFINITE), prefix(i), host(1), i);
    }
    discovered.heard(prefix(0), 35 * SECOND);

    assertEquals(new Admission.Found(), announce(50, "honest", 40 * SECOND));
    assertTrue(discovered.participants().stream().noneMatch(info -> info.name().equals("liar 1")));
    assertEquals(10, discovered.participants().size());
  }

  @Test
  void a_participant_has_a_bounded_number_of_endpoints() {
    announce(1, "a", 0);
    for (int i = 1; i <= 1000; i++) {
      discovered.endpointAnnounced(endpoint(1, i, "t" + i), prefix(1));
    }
    announce(2, "b", 0);

    assertEquals(5, discovered.endpoints().size());
    assertEquals(new Admission.Found(), discovered.endpointAnnounced(endpoint(2, 1, "x"), prefix(2)));
    discovered.endpointLeft(endpoint(1, 1, "t1").guid(), prefix(1), "gone");
    assertEquals(new Admission.Found(), discovered.endpointAnnounced(endpoint(1, 999, "new"), prefix(1)));
  }

  @Test
  void what_a_machine_says_takes_bounded_memory_and_gives_it_back() {
    DiscoveredParticipants large = new DiscoveredParticipants(3, new ParticipantLimits(1000, 100_000, 1, 1, 1));
    ByteBuffer data = ByteBuffer.allocate(16 << 10);
    int taken = 0;
    for (int p = 0; p < 8; p++) {
      large.announced(info(p, "p", 3, Qos.INFINITE), prefix(p), host(1), 0);
      for (int i = 1; i <= 600; i++) {
        EndpointInfo small = endpoint(p, i, "t");
        taken += large.endpointAnnounced(new EndpointInfo(small.guid(), small.kind(), "t", "t", small.qos(), data,
            Locators.NONE, false), prefix(p)) instanceof Admission.Found ? 1 : 0;
      }
    }
    assertTrue(taken > 1500 && taken < 2048, taken + " endpoints of 16 KiB in 32 MiB");
    assertEquals(new Admission.Found(), large.announced(info(90, "p", 3, Qos.INFINITE), prefix(90), host(2), 0));
    for (int p = 0; p < 8; p++) {
      large.left(Guid.participant(prefix(p)), prefix(p), "gone");
    }
    assertEquals(new Admission.Found(), large.announced(info(1, "p", 3, Qos.INFINITE), prefix(1), host(1), 0));
    assertEquals(new Admission.Found(), large.endpointAnnounced(endpoint(1, 1, "t"), prefix(1)));
  }
}
