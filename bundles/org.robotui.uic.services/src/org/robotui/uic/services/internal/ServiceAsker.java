package org.robotui.uic.services.internal;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.UicContext;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Health;
import org.robotui.ui.ask.Asker;
import org.robotui.ui.ask.Catalogue.Entry;

/** Calls services. */
final class ServiceAsker implements Asker {
  private final UicContext context;
  private final Caller<ServiceRequest, ServiceReply> caller;

  ServiceAsker(UicContext context) {
    this.context = context;
    this.caller = context.caller(ServicesType.SERVICES);
  }

  @Override
  public Runnable ask(Entry entry, Map<String, Object> values, Report report) {
    Duration timeout = Duration.ofMillis(Math.round(context.settings().current().number(ServicesType.TIMEOUT) * 1e3));
    ServiceRequest request = new ServiceRequest(entry.item().name(), values);
    SourceId target = caller.targets().stream().filter(t -> t.component().equals(entry.robot().component())).findFirst()
        .orElse(new SourceId(entry.robot().component(), ServicesType.SERVICES.name()));
    report.progress("called");
    Caller.Call<ServiceReply> call = caller.call(target, request, timeout, Caller.Progress.IGNORED);
    call.outcome().thenAccept(outcome -> tell(outcome, timeout, report));
    return call::cancel;
  }

  private static void tell(CallOutcome<ServiceReply> outcome, Duration timeout, Report report) {
    switch (outcome) {
      case CallOutcome.Replied<ServiceReply> r -> report.end(Health.OK, "replied", Optional.of(r.reply().value()));
      case CallOutcome.Failed<ServiceReply> f -> report.end(Health.BAD, f.reason(), Optional.empty());
      case CallOutcome.TimedOut<ServiceReply> t -> report.end(Health.BAD,
          "no reply within " + timeout.toMillis() / 1e3 + " s", Optional.empty());
      case CallOutcome.Cancelled<ServiceReply> c -> report.end(Health.WARNING, "given up", Optional.empty());
    }
  }
}
