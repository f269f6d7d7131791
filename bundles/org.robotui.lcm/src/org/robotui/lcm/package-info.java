/**
 * LCM in Java: connections ({@link org.robotui.lcm.Lcm}) by UDP multicast, through a server, to event logs and in
 * memory.
 *
 * <p>Bytes come from peers and are not trusted: memory and time that they cost are bounded, what is lost or damaged is
 * counted and told with its reason.
 *
 * <p>Usable alone: it needs {@code org.robotui.net}, what the protocol libraries share, and SLF4J.
 *
 * <p>Sources: "UDP Multicast Protocol Description", "LCM Log File format" and "Multicast Setup" in LCM's documentation.
 */
package org.robotui.lcm;
