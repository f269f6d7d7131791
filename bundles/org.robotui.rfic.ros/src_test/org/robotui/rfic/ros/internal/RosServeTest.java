package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import org.robotui.ros.ServiceClient;
import org.robotui.ros.msgs.StandardServices;

/** Services for nodes of the robot that are answered from outside. */
class RosServeTest extends RosRficCase {
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
    await(() -> robot.probeService("/far/lights", PATIENCE).toOptional().isPresent());
    try (ServiceClient<SetBoolRequest, SetBoolResponse> client =
        robot.serviceClient("/far/lights", StandardServices.SET_BOOL, false)) {
      assertTrue(client.call(new SetBoolRequest(true), PATIENCE).toOptional().orElseThrow().success());
      String reason = client.call(new SetBoolRequest(false), PATIENCE).reason();
      assertTrue(reason.contains("the robot is stopped"), reason);
    }
  }

  @Test
  void whatCannotBeOfferedIsRefusedWithAReason() {
    robot.serviceServer("/motors", StandardServices.SET_BOOL, (request, caller) -> new SetBoolResponse(true, ""));
    rfic.start();
    await(() -> refusal("motors", "std_srvs/SetBool").contains("/motors is offered already, by /robot"));
    assertTrue(refusal("x", "demo/Unknown").contains("demo/Unknown"));
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
