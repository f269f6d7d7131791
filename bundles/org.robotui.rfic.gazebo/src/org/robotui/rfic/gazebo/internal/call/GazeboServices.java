package org.robotui.rfic.gazebo.internal.call;

import java.time.Duration;
import java.util.Map;
import java.util.function.Supplier;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.MapRecord;
import org.robotui.gazebo.GazeboNode;
import org.robotui.gazebo.OfferedService;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.net.call.Outcome;
import org.robotui.rfic.gazebo.internal.session.TypeFormats;
import org.robotui.rfic.gazebo.internal.session.WorldTable;

/** Asks services of a partition. */
public final class GazeboServices implements CallHandler<ServiceRequest, ServiceReply> {
  private final GazeboNode node;
  private final TypeFormats formats;
  private final Supplier<WorldTable> table;

  /**
   * Creates a caller.
   *
   * @param node asks
   * @param formats knows how requests and responses are written
   * @param table knows who answers
   */
  public GazeboServices(GazeboNode node, TypeFormats formats, Supplier<WorldTable> table) {
    this.node = node;
    this.formats = formats;
    this.table = table;
  }

  @Override
  public ServiceReply handle(Invocation<ServiceRequest> invocation) throws CallException {
    OfferedService service = service(invocation.request().service());
    Duration left = Duration.ofNanos(Math.max(1_000_000, invocation.deadlineNanos() - System.nanoTime()));
    try {
      return new ServiceReply(CallOutcomes.asked(() -> ask(service, invocation.request().arguments(), left)));
    } catch (IllegalArgumentException e) {
      throw new CallException(service.name().name() + ": " + e.getMessage(), e);
    }
  }

  OfferedService service(String name) throws CallException {
    return table.get().service(name).orElseThrow(() -> new CallException("nobody answers " + name));
  }

  /**
   * Asks a service, which blocks.
   *
   * @param service who is asked
   * @param fields of the request
   * @param patience how long to wait
   * @return the response, without fields where none comes
   * @throws InterruptedException if the thread was interrupted
   * @throws IllegalArgumentException where the request cannot be written, or the response cannot be read
   */
  public Outcome<DynamicRecord> ask(OfferedService service, Map<String, Object> fields, Duration patience)
      throws InterruptedException {
    return node.ask(service, formats.written(service.request(), fields), patience).map(response -> service.isOneWay()
        ? new MapRecord(service.response(), Map.of())
        : formats.of(service.response()).read(response));
  }
}
