/**
 * A client of nodes whose parameters change while they run (dynamic_reconfigure).
 * {@link org.robotui.ros.reconfigure.ReconfigureServers} finds them,
 * {@link org.robotui.ros.reconfigure.ReconfigureClient} follows the description and the values of one of them and asks
 * for others.
 */
package org.robotui.ros.reconfigure;
