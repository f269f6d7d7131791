package org.robotui.core.internal.life;

import java.util.concurrent.Executor;
import java.util.concurrent.ScheduledExecutorService;
import org.robotui.core.internal.command.Arbiter;
import org.robotui.core.internal.command.Sender;
import org.robotui.core.internal.port.CallPool;
import org.robotui.core.internal.port.Link;
import org.robotui.core.internal.time.NanoClock;

/**
 * What the ports of one robot interface are made of.
 *
 * @param component its id
 * @param link its link
 * @param arbiter of its robot
 * @param sender sends its commands
 * @param calls handles its calls
 * @param timer for time-outs
 * @param serial the worker of its RUIC
 * @param clock monotonic
 * @param changed is told that the offers have changed
 */
record RficParts(
    String component,
    Link link,
    Arbiter arbiter,
    Sender sender,
    CallPool calls,
    ScheduledExecutorService timer,
    Executor serial,
    NanoClock clock,
    Runnable changed) {}
