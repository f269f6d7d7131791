package org.robotui.uic.services.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.MapRecord;
import org.robotui.testkit.FakeCaller;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.ui.ask.Asker;
import org.robotui.ui.ask.Catalogue.Entry;

class ServiceAskerTest {
  private static final SourceId FRONT = new SourceId("front", "services");
  private static final SourceId REAR = new SourceId("rear", "services");

  private final FakeUicContext context = new FakeUicContext("services", new ServicesType().schema());
  private final FakeCaller<ServiceRequest, ServiceReply> caller = new FakeCaller<>(FRONT, REAR);
  private final List<String> told = new ArrayList<>();

  private final Asker.Report report = new Asker.Report() {
    @Override
    public void progress(String words) {
      told.add(words);
    }

    @Override
    public void feedback(DynamicRecord record) {
      told.add(record.schema());
    }

    @Override
    public void end(Health health, String words, Optional<DynamicRecord> result) {
      told.add(health + " " + words + result.map(r -> " " + r.schema()).orElse(""));
    }
  };

  @BeforeEach
  void connect() {
    context.caller(ServicesType.SERVICES, caller);
  }

  private FakeCaller.Made<ServiceRequest, ServiceReply> ask() {
    Entry entry = new Entry(new SourceId("rear", "graph"), new Item(Kind.SERVICE, "/stop", ""));
    new ServiceAsker(context).ask(entry, Map.of("data", true), report);
    return caller.made().getFirst();
  }

  @Test
  void asksTheRobotThatHasTheServiceWithinTheTimeOfTheSettings() {
    context.settings().set(ServicesType.TIMEOUT, 2.5);
    FakeCaller.Made<ServiceRequest, ServiceReply> made = ask();
    assertEquals(REAR, made.target());
    assertEquals(new ServiceRequest("/stop", Map.of("data", true)), made.request());
    assertEquals(2500, made.timeout().toMillis());
    made.end().complete(new CallOutcome.Replied<>(new ServiceReply(new MapRecord("Reply", Map.of()))));
    assertEquals(List.of("called", "OK replied Reply"), told);
  }

  @Test
  void tellsWhyThereIsNoReply() {
    ask().end().complete(new CallOutcome.TimedOut<>());
    assertEquals("BAD no reply within 10.0 s", told.getLast());
  }

  @Test
  void tellsThatNobodyIsConnected() {
    context.caller(ServicesType.SERVICES, new FakeCaller<ServiceRequest, ServiceReply>());
    Entry entry = new Entry(new SourceId("rear", "graph"), new Item(Kind.SERVICE, "/stop", ""));
    new ServiceAsker(context).ask(entry, Map.of(), report);
    assertEquals("BAD rear.services is not connected", told.getLast());
  }
}
