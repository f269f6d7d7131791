package org.robotui.api.session;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ThreadFactory;
import org.robotui.api.RficContext;
import org.robotui.api.frame.FrameSink;
import org.robotui.api.link.LinkReporter;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Offers;
import org.robotui.api.time.ClockSource;

/** A context for sessions that offer nothing: it keeps what is said of the link, and the threads. */
final class RecordedLink implements RficContext {
  final List<LinkState> states = new CopyOnWriteArrayList<>();
  final List<Thread> made = new CopyOnWriteArrayList<>();

  List<Thread> alive() {
    return made.stream().filter(Thread::isAlive).toList();
  }

  @Override
  public LinkReporter link() {
    return states::add;
  }

  @Override
  public ThreadFactory threads() {
    return work -> {
      Thread thread = Thread.ofPlatform().daemon().unstarted(work);
      made.add(thread);
      return thread;
    };
  }

  @Override
  public String robot() {
    return "robby";
  }

  @Override
  public String instance() {
    return "base";
  }

  @Override
  public Offers offers() {
    throw new UnsupportedOperationException();
  }

  @Override
  public ClockSource clock() {
    throw new UnsupportedOperationException();
  }

  @Override
  public FrameSink frames() {
    throw new UnsupportedOperationException();
  }

  @Override
  public Path stateFolder() {
    throw new UnsupportedOperationException();
  }
}
