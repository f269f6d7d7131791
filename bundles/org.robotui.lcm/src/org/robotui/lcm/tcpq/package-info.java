/** A server of LCM messages over TCP ({@link org.robotui.lcm.tcpq.TcpqServer}), for places without multicast. */
package org.robotui.lcm.tcpq;
