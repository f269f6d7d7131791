package org.robotui.bridge.internal.carry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.bridge.BridgeStatus.State;
import org.robotui.api.command.Principal;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.ServiceGrant;
import org.robotui.api.port.ServiceOffer;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

class ServiceWayTest {
  private static final Principal USER = new Principal("u", "Ulla", Principal.Kind.WINDOW);
  private static final MapRecord ON =
      new MapRecord("std_srvs/SetBoolRequest", Map.of("data", new FieldValue.Flag(true)));
  private static final MapRecord DONE = new MapRecord("demo/Done", Map.of("ok", new FieldValue.Num(1, "1")));

  private final TwoRobots robots = new TwoRobots();
  private final AtomicReference<ServiceOffer> offer = new AtomicReference<>();
  private final AtomicReference<ServiceRequest> asked = new AtomicReference<>();

  @BeforeEach
  void begin() {
    robots.natalie.ports().offer("base",
        new CallPort<>("serve", ServiceOffer.class, ServiceGrant.class, Arity.MANY, ""));
    robots.natalie.ports().answer(request -> {
      offer.set((ServiceOffer) request);
      return new CallOutcome.Replied<>(new ServiceGrant("/" + offer.get().service(), offer.get().type()));
    });
    robots.keira.ports().offer("base",
        new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY, ""));
    robots.keira.ports().answer(request -> {
      asked.set((ServiceRequest) request);
      return new CallOutcome.Replied<>(new ServiceReply(DONE));
    });
  }

  @AfterEach
  void end() {
    robots.close();
  }

  private void offered(Map<String, Object> more) {
    Map<String, Object> settings = new HashMap<>(Map.of("kind", "service", "type", "std_srvs/SetBool"));
    settings.putAll(more);
    robots.bridge("lights", "gripper:0/open", settings);
    TwoRobots.await(() -> robots.status().state() == State.CARRYING, () -> robots.status().toString());
  }

  private CallOutcome<ServiceReply> call(DynamicRecord request) {
    return offer.get().responder().answer(request, "/client").toCompletableFuture().join();
  }

  private String refusal() {
    CallOutcome<ServiceReply> outcome = call(ON);
    return assertInstanceOf(CallOutcome.Failed.class, outcome).reason();
  }

  @Test
  void what_a_client_asks_is_answered_by_the_call_of_the_other_robot() {
    offered(Map.of());
    assertEquals("offered as /lights (std_srvs/SetBool)", robots.status().text());
    assertEquals(new CallOutcome.Replied<>(new ServiceReply(DONE)), call(ON));
    assertEquals(new ServiceRequest("gripper:0/open", Map.of("data", true)), asked.get());
    assertEquals(Optional.of("Bridge test"), robots.keira.authority().holder().map(Principal::label));
    TwoRobots.await(() -> robots.status().counts().passed() == 1);
  }

  @Test
  void requests_and_replies_are_made_as_written() {
    offered(
        Map.of("fields", Map.of("state.number", "data * 3"), "reply", Map.of("success", "ok", "message", "'as told'")));
    DynamicRecord reply = assertInstanceOf(CallOutcome.Replied.class, call(ON)).reply() instanceof ServiceReply r
        ? r.value()
        : DONE;
    assertEquals(Map.of("state", Map.of("number", 3L)), asked.get().arguments());
    assertEquals(Optional.of(new FieldValue.Text("as told")), reply.field("message"));
    assertEquals(2, reply.fields().size());
  }

  @Test
  void a_call_needs_the_lease_and_ends_with_a_stop() {
    offered(Map.of());
    robots.keira.authority().take(USER, false);
    assertEquals("Ulla has control of Keira; it passes when control is given back", refusal());
    TwoRobots.await(() -> robots.status().state() == State.REFUSED);
    robots.keira.authority().giveBack(USER);
    robots.keira.authority().stop(USER);
    assertTrue(refusal().contains("is stopped by Ulla"));
    TwoRobots.await(() -> robots.status().counts().refused() == 2);
  }

  @Test
  void a_call_that_moves_nothing_needs_none() {
    offered(Map.of("lease", false));
    robots.keira.authority().take(USER, false);
    assertInstanceOf(CallOutcome.Replied.class, call(ON));
    assertEquals(Optional.of("Ulla"), robots.keira.authority().holder().map(Principal::label));
  }

  @Test
  void what_is_missing_is_said() {
    robots.keira.ports().withdraw("base");
    robots.bridge("lights", "open", Map.of("kind", "service", "type", "std_srvs/SetBool"));
    robots.awaitText("cannot be asked now");
    assertFalse(robots.status().counts().received() > 0);
  }

  @Test
  void a_type_that_nobody_says_is_asked_for() {
    robots.bridge("lights", "open", Map.of("kind", "service"));
    robots.awaitText("give the bridge the type");
  }

  @Test
  void a_field_that_is_not_there_is_refused_by_name() {
    offered(Map.of("fields", Map.of("state", "date")));
    assertTrue(refusal().contains("has no 'date' for the field 'state'"));
  }

  @Test
  void who_has_the_offer_still_is_told_that_the_bridge_has_ended() {
    offered(Map.of());
    robots.host.bridging();
    TwoRobots.await(() -> call(ON).equals(new CallOutcome.Failed<>("the bridge 'test' has ended")));
  }
}
