/** What users ask of a robot behind a bridge: services, parameters, what there is. */
package org.robotui.rfic.rosbridge.internal.call;
