package org.robotui.bridge.internal.carry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.bridge.BridgeStatus.State;
import org.robotui.api.command.Principal;
import org.robotui.api.port.ActionOffer;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.ServiceGrant;
import org.robotui.api.port.ServiceOffer;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

class ActionWayTest {
  private static final Principal USER = new Principal("u", "Ulla", Principal.Kind.WINDOW);
  private static final MapRecord GOAL = record("demo/Goal", "x", 3);

  private final TwoRobots robots = new TwoRobots();
  private final AtomicReference<Object> offer = new AtomicReference<>();
  private final AtomicReference<Object> asked = new AtomicReference<>();
  private final AtomicReference<Progress> progress = new AtomicReference<>();
  private final CompletableFuture<CallOutcome<Object>> end = new CompletableFuture<>();
  private final List<String> told = new ArrayList<>();

  private static MapRecord record(String type, String field, double value) {
    return new MapRecord(type, Map.of(field, new FieldValue.Num(value, Long.toString((long) value))));
  }

  @BeforeEach
  void begin() {
    robots.natalie.ports().offer("base",
        new CallPort<>("serve", ServiceOffer.class, ServiceGrant.class, Arity.MANY, ""),
        new CallPort<>("serve_action", ActionOffer.class, ServiceGrant.class, Arity.MANY, ""));
    robots.natalie.ports().answer(request -> {
      offer.set(request);
      return new CallOutcome.Replied<>(new ServiceGrant("/drive", "demo/Drive"));
    });
    robots.keira.ports().answerLater((request, heard) -> {
      asked.set(request);
      progress.set(heard);
      return end;
    });
  }

  @AfterEach
  void end() {
    robots.close();
  }

  private void actions() {
    robots.keira.ports().offer("base",
        new CallPort<>("actions", ActionRequest.class, ActionReply.class, Arity.MANY, "", true));
  }

  private void services() {
    robots.keira.ports().offer("base",
        new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY, ""));
  }

  private void offered(String kind, Map<String, Object> more) {
    Map<String, Object> settings = new HashMap<>(Map.of("kind", kind, "type", "demo/Drive"));
    settings.putAll(more);
    robots.bridge("drive", "move_base", settings);
    TwoRobots.await(() -> robots.status().state() == State.CARRYING, () -> robots.status().toString());
  }

  private Call<ActionReply> goal() {
    return ((ActionOffer) offer.get()).worker().begin(GOAL, "/client", new Progress() {
      @Override
      public void at(double fraction, String message) {
        told.add(message);
      }

      @Override
      public void feedback(DynamicRecord record) {
        told.add(record.fields() + "=" + ((FieldValue.Num) record.field(record.fields().getFirst()).orElseThrow())
            .value());
      }
    });
  }

  private static CallOutcome<ActionReply> outcome(Call<ActionReply> call) {
    return call.outcome().toCompletableFuture().join();
  }

  @Test
  void aGoalIsCarriedOutByTheOtherRobotUnderTheLease() {
    actions();
    offered("action", Map.of("fields", Map.of("target", "x * 10"), "feedback", Map.of("at", "x + 1"),
        "reply", Map.of("code", "x - 1")));
    Call<ActionReply> call = goal();
    assertEquals(new ActionRequest("move_base", Map.of("target", 30L)), asked.get());
    assertEquals(Optional.of("Bridge test"), robots.keira.authority().holder().map(Principal::label));
    progress.get().at(Double.NaN, "active");
    progress.get().feedback(record("demo/Feedback", "x", 4));
    progress.get().feedback(record("demo/Other", "y", 4));
    assertEquals(List.of("active", "[at]=5.0"), told);
    end.complete(new CallOutcome.Replied<>(
        new ActionReply(ActionReply.End.ABORTED, "no way", Optional.of(record("demo/Result", "x", 8)))));
    ActionReply reply = assertInstanceOf(CallOutcome.Replied.class, outcome(call)).reply() instanceof ActionReply r ? r
        : null;
    assertEquals(ActionReply.End.ABORTED, reply.end());
    assertEquals("no way", reply.text());
    assertEquals(Optional.of(new FieldValue.Num(7, "7")), reply.result().orElseThrow().field("code"));
    TwoRobots.await(() -> robots.status().counts().passed() == 1);
  }

  @Test
  void aCancelledGoalIsCancelledThereAndSoIsOneWhoseBridgeEnds() {
    actions();
    offered("action", Map.of());
    goal().cancel();
    assertEquals(1, robots.keira.ports().sent().stream().filter("cancel"::equals).count());
    robots.host.bridging();
    TwoRobots.await(() -> robots.keira.ports().sent().stream().filter("cancel"::equals).count() == 2);
    TwoRobots.await(() -> robots.keira.authority().holder().isEmpty());
  }

  @Test
  void aGoalNeedsTheLeaseAlsoWhereOthersDoNot() {
    actions();
    offered("action", Map.of("lease", false));
    robots.keira.authority().take(USER, false);
    assertEquals(new CallOutcome.Failed<>("Ulla has control of Keira; it passes when control is given back"),
        outcome(goal()));
    assertTrue(told.isEmpty(), "a goal that nobody works on is rejected");
    robots.keira.authority().giveBack(USER);
    robots.keira.authority().stop(USER);
    assertTrue(((CallOutcome.Failed<?>) outcome(goal())).reason().contains("is stopped by Ulla"));
  }

  @Test
  void aRobotWithCallsOnlyCarriesOutGoalsByThem() {
    services();
    offered("action", Map.of());
    Call<ActionReply> call = goal();
    assertEquals(new ServiceRequest("move_base", Map.of("x", 3L)), asked.get());
    assertEquals(List.of("active"), told);
    MapRecord refusal = new MapRecord("demo/Answer",
        Map.of("success", new FieldValue.Flag(false), "message", new FieldValue.Text("blocked")));
    end.complete(new CallOutcome.Replied<>(new ServiceReply(refusal)));
    assertEquals(new CallOutcome.Replied<>(new ActionReply(ActionReply.End.ABORTED, "blocked", Optional.of(refusal))),
        outcome(call));
  }

  @Test
  void anActionAnswersTheCallsOfAService() {
    actions();
    offered("service", Map.of("reply", Map.of("success", "1")));
    ServiceOffer service = (ServiceOffer) offer.get();
    CompletableFuture<CallOutcome<ServiceReply>> answer =
        service.responder().answer(GOAL, "/client").toCompletableFuture();
    assertEquals(new ActionRequest("move_base", Map.of("x", 3L)), asked.get());
    assertFalse(answer.isDone());
    end.complete(new CallOutcome.Replied<>(
        new ActionReply(ActionReply.End.SUCCEEDED, "", Optional.of(record("demo/Result", "x", 8)))));
    assertEquals(List.of("success"),
        assertInstanceOf(CallOutcome.Replied.class, answer.join()).reply() instanceof ServiceReply r
            ? r.value().fields()
            : List.of());
  }

  @Test
  void aServiceWhoseGoalIsNotReachedIsRefusedWithTheReason() {
    actions();
    offered("service", Map.of());
    end.complete(new CallOutcome.Replied<>(new ActionReply(ActionReply.End.PREEMPTED, "stopped", Optional.empty())));
    assertEquals(new CallOutcome.Failed<>("the goal was preempted: stopped"),
        ((ServiceOffer) offer.get()).responder().answer(GOAL, "").toCompletableFuture().join());
  }
}
