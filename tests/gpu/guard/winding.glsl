float winding(Surface at_2, uint count) {
    float x_1 = 0.0;
    uint i = 0u;
    x_1 = at_2.uv.x;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e22 = i;
            i = (_e22 + 1u);
        }
        loop_init = false;
        bool _e32 = loopEnds(1u);
        if (_e32) {
            break;
        }
        uint _e7 = i;
        if ((_e7 < count)) {
        } else {
            break;
        }
        {
            uint _e9 = i;
            if (((_e9 % 3u) == 0u)) {
                continue;
            }
            while(true) {
                bool _e34 = loopEnds(2u);
                if (_e34) {
                    break;
                }
                float _e14 = x_1;
                if ((_e14 < 0.5)) {
                } else {
                    break;
                }
                {
                    float _e17 = x_1;
                    float _e18 = x_1;
                    float _e19 = windingPart(_e18);
                    x_1 = (_e17 + _e19);
                }
            }
        }
    }
    switch(count) {
        case 1u: {
            bool loop_init_1 = true;
            while(true) {
                if (!loop_init_1) {
                    float _e27 = x_1;
                    if ((_e27 < 0.5)) {
                        break;
                    }
                }
                loop_init_1 = false;
                bool _e36 = loopEnds(3u);
                if (_e36) {
                    break;
                }
                float _e24 = x_1;
                x_1 = (_e24 - 0.25);
            }
            break;
        }
        default: {
            break;
        }
    }
    float _e30 = x_1;
    return _e30;
}

vec3 background(vec3 direction_1) {
    Surface _e1 = skyPoint(direction_1);
    allowSteps();
    float _e3 = winding(_e1, 10u);
    return vec3(_e3);
}
