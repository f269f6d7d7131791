package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.robotui.ros.LinkEvent.Kind;

class MasterRestartTest {

  @Test
  void everythingIsRegisteredAgainAndLinksStay() throws Exception {
    LinkLog links = new LinkLog();
    List<Optional<XmlRpcValue>> values = new CopyOnWriteArrayList<>();
    List<String> heard = new CopyOnWriteArrayList<>();
    try (Graph graph = new Graph()) {
      Publisher<String> publisher =
          graph.node("talker").publisher("chatter", new TextCodec(), PublisherOptions.standard());
      RosNode listener = graph.node("listener", links);
      listener.subscriber("chatter", new TextCodec(), SubscriberOptions.standard(),
          (text, reception) -> heard.add(text));
      listener.parameters().subscribe("/speed", (key, value) -> values.add(value));
      Eventually.await("a link", () -> publisher.numSubscribers() == 1 && values.size() == 1);
      graph.restartMaster();
      Eventually.await("the new master knows both", () -> listener.master().systemState().toOptional()
          .map(state -> state.nodes().containsAll(List.of("/talker", "/listener"))).orElse(false));
      publisher.publish("same link");
      Eventually.await("the message", () -> heard.equals(List.of("same link")));
      assertEquals(1, links.connected(Kind.SUBSCRIPTION));
      Eventually.await("the parameter is watched again", () -> values.size() >= 2);
      graph.node("other").parameters().set("/speed", XmlRpcValue.of(3));
      Eventually.await("its new value", () -> values.contains(Optional.of(XmlRpcValue.of(3))));
    }
  }
}
