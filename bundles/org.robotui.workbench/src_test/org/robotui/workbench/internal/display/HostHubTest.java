package org.robotui.workbench.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.testkit.host.FakeHost;

class HostHubTest {
  private final FakeHost host = new FakeHost();
  private final Deque<Runnable> display = new ArrayDeque<>();
  private final HostHub hub = new HostHub(host, display::add);
  private final List<String> told = new ArrayList<>();

  HostHubTest() {
    hub.add(new HostHub.Client() {
      @Override
      public void ruicsChanged() {
        told.add("ruics");
      }

      @Override
      public void ruicChanged(String ruic) {
        told.add(ruic);
      }

      @Override
      public void frameReady(String ruic, String uic) {
        told.add(ruic + "/" + uic);
      }

      @Override
      public void alert(String ruic, String message) {
        told.add(message);
      }
    });
  }

  @Test
  void anyNumberOfFramesOfAViewIsOnePaint() {
    for (int i = 0; i < 100; i++) {
      host.tell(l -> l.frameReady("a", "map"));
    }
    host.tell(l -> l.frameReady("a", "camera"));

    assertEquals(1, display.size());
    run();
    assertEquals(List.of("a/map", "a/camera"), told);
  }

  @Test
  void everythingIsToldInOrder() {
    host.tell(l -> l.ruicsChanged());
    host.tell(l -> l.ruicChanged("a"));
    host.tell(l -> l.alert("a", "fenced"));
    run();

    assertEquals(List.of("ruics", "a", "fenced"), told);
  }

  @Test
  void whatComesAfterADeliveryIsDeliveredToo() {
    host.tell(l -> l.ruicChanged("a"));
    run();
    host.tell(l -> l.ruicChanged("a"));
    run();

    assertEquals(List.of("a", "a"), told);
  }

  @Test
  void aClientThatThrowsKeepsNobodyFromBeingTold() {
    List<String> heard = new ArrayList<>();
    hub.add(new HostHub.Client() {
      @Override
      public void ruicsChanged() {
        throw new NoClassDefFoundError("a view whose bundle is incomplete");
      }

      @Override
      public void ruicChanged(String ruic) {
        heard.add(ruic);
        throw new IllegalStateException("a broken view");
      }
    });
    List<String> later = new ArrayList<>();
    hub.add(new HostHub.Client() {
      @Override
      public void ruicsChanged() {
        later.add("ruics");
      }
    });
    host.tell(l -> l.ruicsChanged());
    host.tell(l -> l.ruicChanged("a"));
    host.tell(l -> l.ruicChanged("b"));
    run();

    assertEquals(List.of("ruics", "a", "b"), told);
    assertEquals(List.of("a", "b"), heard);
    assertEquals(List.of("ruics"), later);
  }

  @Test
  void aClosedHubListensNoMore() {
    hub.close();

    assertEquals(0, host.listeners());
  }

  private void run() {
    while (!display.isEmpty()) {
      display.poll().run();
    }
  }
}
