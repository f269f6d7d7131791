package org.robotui.rfic.ros2.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.ServiceGrant;
import org.robotui.api.port.ServiceOffer;
import org.robotui.api.port.ServiceReply;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.message.ros.std_srvs.SetBoolRequest;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.ros2.Ros2ServiceClient;
import org.robotui.ros2.Ros2ServiceCodec;

/** Services for nodes of the robot that are answered from outside. */
class Ros2ServeTest extends Ros2Case {
  private static final Ros2ServiceCodec<SetBoolRequest, SetBoolResponse> SET_BOOL =
      Ros2ServiceCodec.of("std_srvs/srv/SetBool", SetBoolRequest.class, SetBoolResponse.class);
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private static ServiceOffer offer(String service, String type, CallOutcome<ServiceReply> answer) {
    return new ServiceOffer(service, type, (request, caller) -> CompletableFuture.completedStage(
        request.field("data").equals(Optional.of(new FieldValue.Flag(true))) ? answer
            : new CallOutcome.Failed<>("the robot is stopped")));
  }

  @Test
  void aNodeCallsWhatIsOfferedAndIsToldWhyNot() throws Exception {
    rfic.start();
    ServiceGrant grant = call("serve", offer("far/lights", "std_srvs/SetBool", new CallOutcome.Replied<>(
        new ServiceReply(new MapRecord("far", Map.of("success", new FieldValue.Num(1, "1")))))));
    assertEquals(new ServiceGrant("/far/lights", "std_srvs/SetBool"), grant);
    try (Ros2ServiceClient<SetBoolRequest, SetBoolResponse> client = robot.serviceClient("far/lights", SET_BOOL)) {
      assertTrue(client.call(new SetBoolRequest(true), PATIENCE).toOptional().orElseThrow().success());
      assertEquals(new SetBoolResponse(false, "the robot is stopped"),
          client.call(new SetBoolRequest(false), PATIENCE).toOptional().orElseThrow());
    }
  }

  @Test
  void whatCannotBeOfferedIsRefusedWithAReason() {
    robot.serviceServer("motors", SET_BOOL, (request, caller) -> new SetBoolResponse(true, ""));
    rfic.start();
    await(() -> refusal("motors", "std_srvs/SetBool").contains("/motors is offered already, by /robot"));
    assertTrue(refusal("x", "demo/Unknown").contains("demo/srv/Unknown"));
  }

  /** Nothing where it could be offered. */
  private String refusal(String service, String type) {
    try {
      call("serve", offer(service, type, new CallOutcome.TimedOut<>()));
      return "";
    } catch (CallException e) {
      return e.getMessage();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }
}
