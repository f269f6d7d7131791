package org.robotui.rfic.smartsoft.internal.call;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.record.MapRecord;
import org.robotui.message.DefinitionException;
import org.robotui.message.MessageException;
import org.robotui.message.data.MessageRecord;
import org.robotui.rfic.smartsoft.internal.feed.SmartServices;
import org.robotui.rfic.smartsoft.internal.feed.SmartCommanding;
import org.robotui.smartsoft.client.EventClient;
import org.robotui.smartsoft.client.EventMode;
import org.robotui.smartsoft.client.QueryClient;
import org.robotui.smartsoft.client.SendClient;
import org.robotui.smartsoft.naming.NamedService;
import org.robotui.smartsoft.naming.ServiceName;
import org.robotui.smartsoft.naming.SmartPattern;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.wire.LinkOptions;

/** Asks and tells components. Each call is a connection of its own, of which nothing is left behind. */
public final class SmartCalls implements CallHandler<ServiceRequest, ServiceReply> {
  private final SmartServices services;
  private final LinkOptions links;

  public SmartCalls(SmartServices services, LinkOptions links) {
    this.services = services;
    this.links = links;
  }

  /** Whether a service is for calls. */
  static boolean takes(ServiceName name) {
    return name.known().filter(pattern -> pattern != SmartPattern.PUSH).isPresent()
        && !name.types().equals(List.of(SmartCommanding.VELOCITY));
  }

  @Override
  public ServiceReply handle(Invocation<ServiceRequest> invocation) throws CallException, InterruptedException {
    ServiceRequest asked = invocation.request();
    NamedService service = services.find(asked.service()).filter(known -> takes(known.name()))
        .orElseThrow(() -> new CallException("no component takes '" + asked.service() + "' from calls"));
    try {
      CommType type = services.described(service.name().types().getFirst());
      ByteBuffer said = type.bytes(asked.arguments());
      Duration left = Duration.ofNanos(Math.max(1, invocation.deadlineNanos() - System.nanoTime()));
      return switch (service.name().known().orElseThrow()) {
        case SEND -> sent(service, said);
        case QUERY -> new ServiceReply(answer(service, queried(service, said, left)));
        case EVENT, PUSH -> new ServiceReply(answer(service, happened(service, said, left)));
      };
    } catch (IOException | MessageException | DefinitionException e) {
      throw new CallException(e.getMessage(), e);
    }
  }

  private MessageRecord answer(NamedService service, ByteBuffer object) throws DefinitionException, MessageException {
    return new MessageRecord(services.described(service.name().types().getLast()).read(object));
  }

  private ServiceReply sent(NamedService service, ByteBuffer object) throws IOException, CallException {
    try (SendClient client = SendClient.connect(service.address(), links)) {
      if (!client.send(object)) {
        throw new CallException(service.name().path() + " takes nothing more");
      }
      return new ServiceReply(new MapRecord("sent", Map.of()));
    }
  }

  private ByteBuffer queried(NamedService service, ByteBuffer request, Duration patience) throws IOException {
    try (QueryClient client = QueryClient.connect(service.address(), links)) {
      return client.query(request, patience);
    }
  }

  /** Waits until an event happens once. */
  private ByteBuffer happened(NamedService service, ByteBuffer parameter, Duration patience)
      throws IOException, CallException, InterruptedException {
    CompletableFuture<ByteBuffer> event = new CompletableFuture<>();
    EventClient.Listener listener = new EventClient.Listener() {
      @Override
      public void fired(int activation, ByteBuffer object) {
        event.complete(object);
      }

      @Override
      public void ended(String reason) {
        event.completeExceptionally(new IOException(reason));
      }
    };
    try (EventClient client = EventClient.connect(service.address(), links, listener)) {
      client.activate(EventMode.SINGLE, parameter);
      return event.get(patience.toNanos(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      throw new CallException(service.name().path() + " did not happen in time", e);
    } catch (ExecutionException e) {
      throw new CallException(service.name().path() + ": " + e.getCause().getMessage(), e);
    }
  }
}
